// The window's words as text and controls, for screen readers: the status bar, the selected parameter, and
// the open lesson, which can be done here alone. The lesson is seen while it has the keyboard focus.

const lesson = document.querySelector('#lesson');
const part = (selector) => lesson.querySelector(selector);

function write(element, text) {
    if (element.textContent !== text) // a live region is read again when it is written
        element.textContent = text;
}

function button(text, act) {
    const made = document.createElement('button');
    made.type = 'button';
    made.textContent = text;
    made.addEventListener('click', act);
    return made;
}

function showAnswers(step, actions) {
    const list = part('ol');
    const old = [...list.querySelectorAll('button')];
    if (old.length !== step.answers.length || old.some((each, i) => each.textContent !== step.answers[i])) {
        list.replaceChildren(...step.answers.map((answer, i) => {
            const item = document.createElement('li');
            item.append(button(answer, () => actions.answer(i)));
            return item;
        }));
    }
    list.querySelectorAll('button').forEach((each, i) => each.setAttribute('aria-pressed', i === step.chosen));
}

// `spoken` is a stage::Spoken; `actions` are { answer(number), goToStep(number) }, counted from 0.
export function show(spoken, actions) {
    document.documentElement.lang = spoken.language;
    write(document.querySelector('#status'), spoken.status);
    write(document.querySelector('#row'), spoken.row);
    const { step } = spoken;
    lesson.hidden = !step;
    if (!step)
        return;
    write(part('h1'), step.lesson);
    write(part('h2'), `${step.step + 1} / ${step.steps} ${step.title}`);
    write(part('.text'), step.text);
    write(part('.task'), step.task);
    showAnswers(step, actions);
    write(part('.verdict'), step.verdict);
    const to = (selector, number) => {
        const isThere = number >= 0 && number < step.steps;
        part(selector).setAttribute('aria-disabled', !isThere); // it keeps the focus
        part(selector).onclick = () => isThere && actions.goToStep(number);
    };
    to('.previous', step.step - 1);
    to('.next', step.step + 1);
}

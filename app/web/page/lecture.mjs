// An example of a page around the window: its buttons send messages, and it hears how far a lesson is (docs/web.md).

const scene = document.querySelector('#scene');
const lesson = document.querySelector('#lesson');
const said = document.querySelector('#said');
const progress = document.querySelector('#progress');
const originOf = (frame) => new URL(frame.src).origin;
const send = (frame, message) => frame.contentWindow.postMessage({ texplorer: 1, ...message }, originOf(frame));

for (const button of document.querySelectorAll('[data-path]'))
    button.addEventListener('click', () => send(scene, { id: button.textContent, do: 'set', path: button.dataset.path, value: button.dataset.value }));
for (const button of document.querySelectorAll('[data-open]'))
    button.addEventListener('click', () => send(lesson, { do: 'open', address: button.dataset.open }));

window.addEventListener('message', ({ source, origin, data }) => {
    if (source === scene.contentWindow && origin === originOf(scene) && (data.error || data.id))
        said.textContent = data.error ?? `The texture has ${data.id}.`;
    else if (source === lesson.contentWindow && origin === originOf(lesson) && data.event === 'lesson')
        progress.textContent = `Step ${data.step}: ${data.stepsDone} of ${data.steps} steps are done.`;
});

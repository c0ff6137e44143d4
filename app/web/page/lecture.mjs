// An example of a page around the window: its buttons send messages, and it hears how far a lesson is (docs/web.md).

const frame = document.querySelector('#scene');
const said = document.querySelector('#said');
const progress = document.querySelector('#progress');
const origin = new URL(frame.src).origin;
const send = (message) => frame.contentWindow.postMessage({ texplorer: 1, ...message }, origin);

for (const button of document.querySelectorAll('[data-path]'))
    button.addEventListener('click', () => send({ id: button.textContent, do: 'set', path: button.dataset.path, value: button.dataset.value }));
for (const button of document.querySelectorAll('[data-open]'))
    button.addEventListener('click', () => send({ id: 'lesson', do: 'open', address: button.dataset.open }));

window.addEventListener('message', ({ source, origin: from, data }) => {
    if (source !== frame.contentWindow || from !== origin)
        return;
    if (data.error)
        said.textContent = data.error;
    else if (data.event === 'lesson')
        progress.textContent = `Step ${data.step}: ${data.stepsDone} of ${data.steps} steps are done.`;
    else if (data.id && data.id !== 'lesson')
        said.textContent = `The texture has ${data.id}.`;
});

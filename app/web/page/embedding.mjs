// Messages between this page and the one that shows it in a frame. Only pages of the same origin are heard, and those of the
// origins that the file embed.json of this folder lists.

let heard = null; // the origin of the page around this one, once it has sent a message
let allowed = [];

// `receive` gets each message as JSON. Does nothing in a page that no other one shows.
export async function listen(receive) {
    if (window.parent === window)
        return;
    allowed = [location.origin, ...await fetch('embed.json').then((response) => response.json())
        .then(({ origins }) => (Array.isArray(origins) ? origins : [])).catch(() => [])];
    window.addEventListener('message', ({ source, origin, data }) => {
        if (source !== window.parent || !allowed.includes(origin) || typeof data !== 'object')
            return; // texts are of other libraries
        heard = origin;
        receive(JSON.stringify(data));
    });
    window.addEventListener('keydown', ({ key }) => {
        if (key === 'Escape')
            window.parent.focus(); // else no key would leave the canvas
    });
    const around = document.referrer && new URL(document.referrer).origin;
    if (allowed.includes(around))
        window.parent.postMessage({ texplorer: 1, event: 'ready' }, around);
}

// Sends a message of the program, a JSON text.
export function post(message) {
    if (heard !== null)
        window.parent.postMessage(JSON.parse(message), heard);
}

// What base64 says; spaces and ends of lines mean nothing.
function bytes(text) {
    return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
}

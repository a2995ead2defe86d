// Arrays of the page: base64 of zlib streams of byte planes, first all lowest bytes, and so on.
'use strict';

function bytesOfBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = raw.charCodeAt(i);
  return bytes;
}

async function inflate(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// The array of an element, which is taken out of the page: its text would fill memory.
async function unpack(id, Type) {
  const element = document.getElementById(id);
  const planes = await inflate(bytesOfBase64(element.textContent));
  element.remove();
  if (Type.BYTES_PER_ELEMENT === 1) return new Type(planes.buffer);
  const n = planes.length / 4;
  const words = new Uint32Array(n);
  for (let i = 0; i < n; ++i) {
    words[i] = planes[i] | planes[n + i] << 8 | planes[2 * n + i] << 16 | planes[3 * n + i] << 24;
  }
  return new Type(words.buffer);
}

// Numbers that are appended one by one.
class Growing {
  constructor(Type) {
    this.all = new Type(1024);
    this.size = 0;
  }

  // Three at a time.
  push(a, b, c) {
    if (this.size + 3 > this.all.length) {
      const larger = new this.all.constructor(2 * this.all.length);
      larger.set(this.all);
      this.all = larger;
    }
    this.all[this.size++] = a;
    this.all[this.size++] = b;
    this.all[this.size++] = c;
  }

  get array() { return this.all.subarray(0, this.size); }
}

// Runs firmware that was built for WebAssembly: `node node.mjs FIRMWARE.wasm WORD...`. It serves the
// semihosting calls of semihost.rs as QEMU serves those of a board.
import fs from "node:fs";
import process from "node:process";

const [, , file, ...words] = process.argv;
let memory;
const numbers = (argument) => new Int32Array(memory.buffer, argument);
const bytes = (address, length) => new Uint8Array(memory.buffer, address, length);

// By their numbers in Arm's specification; each gives what the firmware's `call` gives.
const operations = {
  // Open: the console, or a file to be read.
  0x01([name, mode, length]) {
    const text = Buffer.from(bytes(name, length)).toString();
    if (text === ":tt") return process.stdout.fd;
    try {
      return mode === 1 ? fs.openSync(text, "r") : -1;
    } catch {
      return -1;
    }
  },
  // Close.
  0x02([handle]) {
    if (handle !== process.stdout.fd) fs.closeSync(handle);
    return 0;
  },
  // Write: gives how many bytes were not written.
  0x05([handle, address, length]) {
    let written = 0;
    while (written < length) {
      written += fs.writeSync(handle, bytes(address + written, length - written));
    }
    return 0;
  },
  // Read: gives how many bytes are missing.
  0x06([handle, address, length]) {
    let read = 0;
    for (let more = 1; more > 0 && read < length; read += more) {
      more = fs.readSync(handle, bytes(address + read, length - read));
    }
    return length - read;
  },
  // The command line, with a zero after it that its length does not count.
  0x15(block) {
    const text = Buffer.from(["firmware", ...words].join(" ") + "\0");
    if (text.length > block[1]) return -1;
    bytes(block[0], text.length).set(text);
    block[1] = text.length - 1;
    return 0;
  },
  // Exit.
  0x20([, status]) {
    process.exit(status);
  },
};

const host = { semihost: (operation, argument) => operations[operation](numbers(argument)) };
const { instance } = await WebAssembly.instantiate(fs.readFileSync(file), { host });
memory = instance.exports.memory;
instance.exports.run();

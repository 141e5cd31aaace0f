@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.projects

import kotlinx.coroutines.await
import kotlin.io.encoding.Base64
import kotlin.js.Promise

actual suspend fun deflate(bytes: ByteArray): ByteArray = Base64.decode(
    checkNotNull(throughStream(compression(), Base64.encode(bytes), Int.MAX_VALUE).await<JsString?>()).toString(),
)

actual suspend fun inflate(compressed: ByteArray, max: Int): ByteArray? =
    throughStream(decompression(), Base64.encode(compressed), max).await<JsString?>()?.let {
        Base64.decode(it.toString())
    }

private fun compression(): JsAny = js("new CompressionStream('deflate-raw')")

private fun decompression(): JsAny = js("new DecompressionStream('deflate-raw')")

/**
 * The output of [stream] for [input], both in Base64, which passes bytes to JavaScript in one piece; null if the stream
 * rejects the input or returns more than [max] bytes. Reads while it writes, so that it never holds more than that.
 */
private fun throughStream(stream: JsAny, input: String, max: Int): Promise<JsString?> = js(
    """(async () => {
        const writer = stream.writable.getWriter();
        const written = writer.write(Uint8Array.from(atob(input), letter => letter.charCodeAt(0))).then(() => writer.close());
        written.catch(() => undefined);
        const reader = stream.readable.getReader();
        const letters = [];
        let length = 0;
        try {
            for (;;) {
                const { done, value } = await reader.read();
                if (done) break;
                length += value.length;
                if (length > max) {
                    await reader.cancel();
                    return null;
                }
                for (let place = 0; place < value.length; place += 8192) {
                    letters.push(String.fromCharCode(...value.subarray(place, place + 8192)));
                }
            }
            await written;
        } catch (refusal) {
            return null;
        }
        return btoa(letters.join(''));
    })()""",
)

@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.device

/** JavaScript's `Uint8Array`. */
internal external interface JsBytes : JsAny {
    val length: Int
}

internal fun ByteArray.toJs(): JsBytes {
    val copy = newBytes(size)
    for (index in indices) put(copy, index, this[index].toInt())
    return copy
}

internal fun JsBytes.toByteArray(): ByteArray = ByteArray(length) { at(this, it).toByte() }

private fun newBytes(size: Int): JsBytes = js("new Uint8Array(size)")

private fun put(bytes: JsBytes, index: Int, value: Int): Unit = js("{ bytes[index] = value; }")

private fun at(bytes: JsBytes, index: Int): Int = js("bytes[index]")

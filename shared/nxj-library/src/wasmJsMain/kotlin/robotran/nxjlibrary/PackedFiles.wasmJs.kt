@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.nxjlibrary

import kotlinx.coroutines.await
import kotlin.js.Promise

internal actual suspend fun packedClasses(): ByteArray = byteArray(importModule().await().classes().await())

internal actual suspend fun packedSources(): ByteArray = byteArray(importModule().await().sources().await())

/** The functions of `nxj-library.mjs`. */
private external interface NxjLibraryModule : JsAny {
    fun classes(): Promise<JsAny>

    fun sources(): Promise<JsAny>
}

/** Imports the module with the compiler's, which workers know. */
private fun importModule(): Promise<NxjLibraryModule> = js("import(/* webpackChunkName: 'ecj' */ './nxj-library.mjs')")

private fun byteArray(array: JsAny): ByteArray = ByteArray(length(array)) { get(array, it) }

private fun length(array: JsAny): Int = js("array.length")

private fun get(array: JsAny, index: Int): Byte = js("array[index]")

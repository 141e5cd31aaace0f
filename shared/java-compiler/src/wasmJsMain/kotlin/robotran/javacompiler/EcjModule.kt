@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.javacompiler

import kotlin.js.Promise

/** The functions of `EcjModule.java`, compiled to WebAssembly. */
internal external interface EcjModule : JsAny {
    fun clearLibrary()

    fun addLibraryClass(internalName: String, classFile: JsAny)

    fun addSource(path: String, text: String)

    fun compile(): Boolean

    fun classCount(): Int

    fun className(place: Int): String

    fun classFile(place: Int): JsAny

    fun classHasMain(place: Int): Boolean

    fun problemCount(): Int

    fun problemPath(place: Int): String

    fun problemNumber(place: Int): Int

    fun problemIsError(place: Int): Boolean

    fun problemIsSyntax(place: Int): Boolean

    fun problemStart(place: Int): Int

    fun problemEnd(place: Int): Int

    fun problemMessage(place: Int): String

    fun problemArgumentCount(place: Int): Int

    fun problemArgument(place: Int, argument: Int): String

    fun problemMemberCount(place: Int): Int

    fun problemMember(place: Int, member: Int): String
}

/** Imports the module dynamically, so that the page fetches it only on demand and bundlers find it. */
internal fun importEcjModule(): Promise<EcjModule> = js("import('./ecj.mjs').then(module => module.loadModule())")

internal fun ByteArray.toJsArray(): JsAny = newInt8Array(size).also { copy ->
    forEachIndexed { place, value -> put(copy, place, value) }
}

internal fun byteArray(array: JsAny): ByteArray = ByteArray(length(array)) { get(array, it) }

private fun newInt8Array(size: Int): JsAny = js("new Int8Array(size)")

private fun put(array: JsAny, place: Int, value: Byte): Unit = js("{ array[place] = value; }")

private fun length(array: JsAny): Int = js("array.length")

private fun get(array: JsAny, place: Int): Byte = js("array[place]")

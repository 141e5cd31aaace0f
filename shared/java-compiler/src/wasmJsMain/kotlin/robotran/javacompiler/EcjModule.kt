@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.javacompiler

import kotlin.js.Promise

/** The functions of `EcjModule.java`, compiled to WebAssembly. */
internal external interface EcjModule : JsAny {
    fun setTarget(number: Int)

    fun clearLibrary()

    fun addLibraryClass(internalName: String, classFile: JsAny)

    fun addSource(path: String, text: String)

    fun addGap(key: String)

    fun compile(): Boolean

    fun classCount(): Int

    fun className(index: Int): String

    fun classFile(index: Int): JsAny

    fun classHasMain(index: Int): Boolean

    fun problemCount(): Int

    fun problemPath(index: Int): String

    fun problemNumber(index: Int): Int

    fun problemIsError(index: Int): Boolean

    fun problemIsSyntax(index: Int): Boolean

    fun problemStart(index: Int): Int

    fun problemEnd(index: Int): Int

    fun problemMessage(index: Int): String

    fun problemArgumentCount(index: Int): Int

    fun problemArgument(index: Int, argument: Int): String

    fun problemMemberCount(index: Int): Int

    fun problemMember(index: Int, member: Int): String
}

/** Imports the module dynamically, so that the page fetches it only on demand and bundlers find it. */
internal fun importEcjModule(): Promise<EcjModule> =
    js("import(/* webpackChunkName: 'ecj' */ './ecj.mjs').then(module => module.loadModule())")

internal fun ByteArray.toJsArray(): JsAny = newInt8Array(size).also { copy ->
    forEachIndexed { index, value -> put(copy, index, value) }
}

internal fun byteArray(array: JsAny): ByteArray = ByteArray(length(array)) { get(array, it) }

private fun newInt8Array(size: Int): JsAny = js("new Int8Array(size)")

private fun put(array: JsAny, index: Int, value: Byte): Unit = js("{ array[index] = value; }")

private fun length(array: JsAny): Int = js("array.length")

private fun get(array: JsAny, index: Int): Byte = js("array[index]")

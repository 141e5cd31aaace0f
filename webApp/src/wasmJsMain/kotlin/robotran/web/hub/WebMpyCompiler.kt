@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.hub

import robotran.mpycompiler.MpyCompiler
import robotran.mpycompiler.MpyResult
import robotran.web.device.JsBytes
import robotran.web.device.outcome
import robotran.web.device.toByteArray
import kotlin.js.Promise

/** MicroPython's own compiler, which is downloaded when the first program is compiled. */
internal object WebMpyCompiler : MpyCompiler {
    override suspend fun compile(fileName: String, source: String): MpyResult {
        val outcome = compileInPage(fileName, source).outcome()
        if (outcome.error != null) return MpyResult.NotLoaded
        val run = outcome.value
        return MpyResult.of(run.status, run.mpy?.toByteArray(), run.errors.toList().map { it.toString() })
    }
}

/** What `mpy-compiler.mjs` gives. */
private external interface MpyRun : JsAny {
    val status: Int
    val mpy: JsBytes?
    val errors: JsArray<JsString>
}

/** A dynamic import, so that the page loads the module only when it is needed. */
private fun compileInPage(fileName: String, source: String): Promise<MpyRun> = js(
    "import(/* webpackChunkName: 'mpy-compiler' */ './mpy-compiler.mjs').then((module) => module.compile(fileName, source))",
)

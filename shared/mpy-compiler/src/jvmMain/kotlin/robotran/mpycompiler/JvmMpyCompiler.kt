package robotran.mpycompiler

import com.dylibso.chicory.wasm.ChicoryException
import com.dylibso.chicory.wasm.Parser
import com.dylibso.chicory.wasm.WasmModule
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.runInterruptible
import kotlinx.coroutines.withContext
import kotlinx.coroutines.withTimeoutOrNull
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

/**
 * Runs the compiler in an interpreter of WebAssembly, on the desktop and on Android. The first program takes half a second, a
 * usual one then less than a tenth.
 *
 * @param limit how long a program may take. Its time grows with the square of its different names and texts.
 */
class JvmMpyCompiler(private val limit: Duration = 60.seconds) : MpyCompiler {
    override suspend fun compile(fileName: String, source: String): MpyResult = withContext(Dispatchers.Default) {
        val result = withTimeoutOrNull(limit) {
            runInterruptible { compileNow(fileName, source) }
        }
        result ?: MpyResult.Failure(null, "not compiled within $limit")
    }

    private fun compileNow(fileName: String, source: String): MpyResult = try {
        MpyCrossRun(module, fileName, source.encodeToByteArray()).run()
    } catch (failure: ChicoryException) {
        // Python that is nested deeper than the interpreter can follow, or larger than the compiler's memory.
        MpyResult.Failure(null, failure.message.orEmpty())
    }

    private companion object {
        /** Read once; each program gets an instance of its own. */
        val module: WasmModule by lazy {
            // An absolute path, since Android's optimiser may move the class to another package.
            val resource = JvmMpyCompiler::class.java.getResourceAsStream("/robotran/mpycompiler/mpy-cross-v6.wasm")
            checkNotNull(resource) { "There is no compiler for hubs" }.use { Parser.parse(it) }
        }
    }
}

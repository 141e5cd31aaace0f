package robotran.mpycompiler

/**
 * Compiles Python to the bytecode of hubs, `.mpy` of version 6 without machine code. The same source under the same file name
 * gives the same bytes on every platform.
 */
interface MpyCompiler {
    /**
     * Compiles [source].
     *
     * @param fileName as tracebacks are to name it, such as `main.py`. It becomes part of the bytes.
     */
    suspend fun compile(fileName: String, source: String): MpyResult
}

/** The result of compiling. */
sealed interface MpyResult {
    class Success(val mpy: ByteArray) : MpyResult

    /**
     * Python that cannot be compiled.
     *
     * @property line of the source, from 1; null if the compiler names none.
     * @property message what the compiler says, in English, such as `SyntaxError: invalid syntax`.
     */
    data class Failure(val line: Int?, val message: String) : MpyResult

    /** The compiler could not be fetched. Only a page has to fetch it. */
    data object NotLoaded : MpyResult

    companion object {
        /**
         * The result of a run of the compiler.
         *
         * @param status what it ended with, 0 for good.
         * @param mpy the file that it wrote, if it did.
         * @param errors what it printed about mistakes: a traceback whose last line names the mistake.
         */
        fun of(status: Int, mpy: ByteArray?, errors: List<String>): MpyResult {
            if (status == 0 && mpy != null && mpy.isNotEmpty()) return Success(mpy)
            val said = errors.filter { it.isNotBlank() }
            val line = said.firstNotNullOfOrNull { PLACE.find(it) }?.let { it.groupValues[1].toIntOrNull() }
            return Failure(line, said.lastOrNull()?.trim() ?: "status $status")
        }

        private val PLACE = Regex("""^ +File ".*", line (\d+)""")
    }
}

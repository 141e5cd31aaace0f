package robotran.microbitlink.simulated

/**
 * What Python does with the lines that write and read a file.
 *
 * @param write puts all files into the flash; false if they have no room.
 */
internal class SimulatedFile(private val write: (Map<String, ByteArray>) -> Boolean) {
    private var name: String? = null
    private var content = ByteArray(0)

    fun forget() {
        name = null
    }

    /** What [lines] print, and why they end early. */
    fun run(lines: String, files: Map<String, ByteArray>): Pair<String, String> {
        val written = WRITE.matchEntire(lines)
        val opened = OPEN.matchEntire(lines)
        val known = name
        return when {
            opened != null -> open(opened.groupValues[1], files)
            written != null && known != null -> write(known, bytesOf(written.groupValues[1]), files)
            lines == "f.close()" && known != null -> "".also { name = null } to ""
            READ.matches(lines) -> files[READ.find(lines)?.groupValues?.get(1)]?.let { told(it) }
                ?: ("" to error("OSError: file not found"))
            else -> "" to error("SyntaxError: invalid syntax")
        }
    }

    private fun open(opened: String, files: Map<String, ByteArray>): Pair<String, String> {
        name = opened
        content = ByteArray(0)
        write(files - opened)
        return "" to ""
    }

    private fun write(file: String, bytes: ByteArray?, files: Map<String, ByteArray>): Pair<String, String> {
        if (bytes == null) return "" to error("SyntaxError: invalid syntax")
        content += bytes
        return if (write(files + (file to content))) "" to "" else "" to error("OSError: [Errno 28] ENOSPC")
    }

    /** What the app's Python prints of the file with [bytes]. */
    private fun told(bytes: ByteArray): Pair<String, String> {
        var a = 7L
        var b = 1L
        for (byte in bytes) {
            a = (a * 31 + (byte.toInt() and 0xFF)) % 16_777_213
            b = (b * 37 + (byte.toInt() and 0xFF)) % 16_777_199
        }
        return "${bytes.size} $a $b\r\n" to ""
    }

    private fun error(python: String) =
        "Traceback (most recent call last):\r\n  File \"<stdin>\", line 1\r\n$python\r\n"

    /** The bytes of a literal; null if it is none. */
    private fun bytesOf(literal: String): ByteArray? {
        if (!LITERAL.matches(literal)) return null
        return PART.findAll(literal).map { part ->
            val hex = part.groupValues[1]
            if (hex.isEmpty()) part.value.single().code.toByte() else hex.toInt(16).toByte()
        }.toList().toByteArray()
    }

    private companion object {
        val OPEN = Regex("""f=open\('([^']+)','wb'\)""")
        val WRITE = Regex("""f\.write\(b'(.*)'\)""")
        val READ =
            Regex("""f=open\('([^']+)','rb'\)\nn=0\na=7\nb=1\nwhile True:\n d=f\.read\(32\)\n[\s\S]+print\(n,a,b\)""")
        val PART = Regex("""\\x([0-9a-f]{2})|[^\\']""")
        val LITERAL = Regex("""(?:\\x[0-9a-f]{2}|[^\\'])*""")
    }
}

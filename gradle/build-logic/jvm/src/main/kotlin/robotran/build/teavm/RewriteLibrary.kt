package robotran.build.teavm

import org.gradle.api.DefaultTask
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.tasks.Classpath
import org.gradle.api.tasks.OutputFile
import java.util.zip.ZipEntry
import java.util.zip.ZipFile
import java.util.zip.ZipOutputStream

/** Copies a jar and rewrites its class files. The output is reproducible. */
abstract class RewriteLibrary : DefaultTask() {
    /** The jar to rewrite. */
    @get:Classpath
    abstract val library: ConfigurableFileCollection

    @get:OutputFile
    abstract val rewrittenLibrary: RegularFileProperty

    /** @param isKept whether to keep a file, by its path in the jar. */
    protected fun copy(isKept: (String) -> Boolean = { true }, rewritten: (ByteArray) -> ByteArray) {
        ZipFile(library.singleFile).use { source ->
            ZipOutputStream(rewrittenLibrary.get().asFile.outputStream().buffered()).use { target ->
                val entries = source.entries().asSequence().filterNot(::describesOriginal).filter { isKept(it.name) }
                entries.sortedBy { it.name }.forEach { entry ->
                    val bytes = source.getInputStream(entry).use { it.readBytes() }
                    target.putNextEntry(ZipEntry(entry.name).apply { timeLocal = REPRODUCIBLE_TIME })
                    target.write(if (entry.name.endsWith(".class")) rewritten(bytes) else bytes)
                    target.closeEntry()
                }
            }
        }
    }

    // Module descriptors, manifests and signatures describe the original jar.
    private fun describesOriginal(entry: ZipEntry) =
        entry.isDirectory || entry.name.endsWith("module-info.class") || entry.name == "META-INF/MANIFEST.MF" ||
            SIGNATURE.matches(entry.name)

    private companion object {
        val REPRODUCIBLE_TIME: java.time.LocalDateTime = java.time.LocalDateTime.of(1980, 2, 1, 0, 0)
        val SIGNATURE = Regex("""META-INF/[^/]+\.(SF|RSA|DSA|EC)""")
    }
}

package robotran.build.physics

import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.provider.Property
import org.gradle.api.provider.SetProperty
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Classpath
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.OutputFile
import org.gradle.api.tasks.TaskAction
import java.util.zip.ZipEntry
import java.util.zip.ZipFile
import java.util.zip.ZipOutputStream

/**
 * Copies a jar and lets its calls of `java.lang.Math` functions whose last bit differs from platform to platform go to one
 * implementation in pure Java. Fails if the jar calls a function that is neither known to be exact nor replaced.
 */
@CacheableTask
abstract class RewriteMathCalls : DefaultTask() {
    /** The one jar to rewrite. */
    @get:Classpath
    abstract val library: ConfigurableFileCollection

    /** Names of the functions that IEEE 754 and Java's definition leave no freedom to, so that they may stay. */
    @get:Input
    abstract val exactFunctions: SetProperty<String>

    /** Names of the functions to replace by those of the same name and parameters in [replacement]. */
    @get:Input
    abstract val replacedFunctions: SetProperty<String>

    /** Internal name of the class that is called instead, such as `org/example/Functions`. */
    @get:Input
    abstract val replacement: Property<String>

    @get:OutputFile
    abstract val rewrittenLibrary: RegularFileProperty

    @TaskAction
    fun rewrite() {
        val rewriter = MathCallRewriter(exactFunctions.get(), replacedFunctions.get(), replacement.get())
        ZipFile(library.singleFile).use { source ->
            ZipOutputStream(rewrittenLibrary.get().asFile.outputStream().buffered()).use { target ->
                source.entries().asSequence().filterNot(::describesOriginal).sortedBy { it.name }.forEach { entry ->
                    val bytes = source.getInputStream(entry).use { it.readBytes() }
                    target.putNextEntry(ZipEntry(entry.name).apply { timeLocal = REPRODUCIBLE_TIME })
                    target.write(if (entry.name.endsWith(".class")) rewriter.rewrite(bytes) else bytes)
                    target.closeEntry()
                }
            }
        }
        if (rewriter.unknownCalls.isNotEmpty()) {
            throw GradleException("${library.singleFile.name} calls functions that may differ between platforms: ${rewriter.unknownCalls}")
        }
    }

    // A module descriptor and a manifest name the dependencies of the jar as it was.
    private fun describesOriginal(entry: ZipEntry) =
        entry.isDirectory || entry.name.endsWith("module-info.class") || entry.name == "META-INF/MANIFEST.MF"

    private companion object {
        val REPRODUCIBLE_TIME: java.time.LocalDateTime = java.time.LocalDateTime.of(1980, 2, 1, 0, 0)
    }
}

package robotran.build.lejos

import org.eclipse.jdt.core.compiler.batch.BatchCompiler
import org.gradle.api.GradleException
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.provider.Property
import org.gradle.workers.WorkAction
import org.gradle.workers.WorkParameters
import java.io.File
import java.io.PrintWriter
import java.io.StringWriter
import java.util.Base64

/** The part of [CompileForBrick] that uses ECJ's classes. */
internal abstract class CompileForBrickAction : WorkAction<CompileForBrickAction.Parameters> {
    interface Parameters : WorkParameters {
        val sources: ConfigurableFileCollection
        val sourceFolder: DirectoryProperty
        val language: Property<String>
        val classFiles: Property<String>
        val eachAlone: Property<Boolean>
        val library: ConfigurableFileCollection

        /** An empty folder that replaces the JDK's classes. */
        val noClasses: DirectoryProperty
        val classFolder: DirectoryProperty
        val textFolder: DirectoryProperty
    }

    override fun execute() {
        val classes = parameters.classFolder.get().asFile
        val texts = parameters.textFolder.get().asFile
        classes.deleteRecursively()
        texts.deleteRecursively()
        val sources = parameters.sources.files.sorted()
        if (parameters.eachAlone.get()) {
            sources.filterNot(::expectsErrors).forEach {
                compileAlone(it, classes)
            }
        } else {
            compile(sources, classes)
        }
        classes.walk().filter { it.isFile }.forEach { file ->
            val text = texts.resolve(file.relativeTo(classes).path)
            text.parentFile.mkdirs()
            text.writeText(Base64.getEncoder().encodeToString(file.readBytes()))
        }
    }

    private fun expectsErrors(source: File) = source.readLines().any { it.startsWith(MISTAKE) }

    private fun compileAlone(source: File, classes: File) =
        compile(listOf(source), classes.resolve(source.relativeTo(parameters.sourceFolder.get().asFile).path))

    private fun compile(sources: List<File>, classes: File) {
        val problems = StringWriter()
        val library = (parameters.library.files.singleOrNull() ?: parameters.noClasses.get().asFile).path
        val places = listOf("-bootclasspath", library, "-classpath", library, "-d", classes.path)
        val output = PrintWriter(problems)
        val versions = listOf("-source", parameters.language.get(), "-target", parameters.classFiles.get())
        val arguments = versions + OPTIONS + places + sources.map { it.path }
        if (!BatchCompiler.compile(arguments.toTypedArray(), output, output, null)) {
            throw GradleException("This does not compile for a brick:\n$problems")
        }
    }

    private companion object {
        const val MISTAKE = "// error "
        val OPTIONS =
            listOf(
                "-proc:none",
                "-g",
                "-preserveAllLocals",
                "-nowarn",
                "-encoding",
                "UTF-8",
            )
    }
}

package robotran.build.lejos

import org.eclipse.jdt.core.compiler.batch.BatchCompiler
import org.gradle.api.GradleException
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.DirectoryProperty
import org.gradle.workers.WorkAction
import org.gradle.workers.WorkParameters
import java.io.File
import java.io.PrintWriter
import java.io.StringWriter
import java.util.Base64

/** The part of [CompileForBrick] that sees ECJ's classes. */
internal abstract class CompileForBrickAction : WorkAction<CompileForBrickAction.Parameters> {
    interface Parameters : WorkParameters {
        val sources: ConfigurableFileCollection

        /** A folder with nothing in it, in the place of the JDK's classes. */
        val noClasses: DirectoryProperty
        val classFolder: DirectoryProperty
        val textFolder: DirectoryProperty
    }

    override fun execute() {
        val classes = parameters.classFolder.get().asFile
        val texts = parameters.textFolder.get().asFile
        classes.deleteRecursively()
        texts.deleteRecursively()
        compile(classes)
        classes.walk().filter { it.isFile }.forEach { file ->
            val text = texts.resolve(file.relativeTo(classes).path)
            text.parentFile.mkdirs()
            text.writeText(Base64.getEncoder().encodeToString(file.readBytes()))
        }
    }

    private fun compile(classes: File) {
        val problems = StringWriter()
        val sources = parameters.sources.files.map { it.path }.sorted()
        val noClasses = parameters.noClasses.get().asFile.path
        val places = listOf("-bootclasspath", noClasses, "-classpath", noClasses, "-d", classes.path)
        val output = PrintWriter(problems)
        if (!BatchCompiler.compile((OPTIONS + places + sources).toTypedArray(), output, output, null)) {
            throw GradleException("The library of leJOS does not compile:\n$problems")
        }
    }

    private companion object {
        val OPTIONS = listOf("-source", "1.3", "-target", "1.1", "-proc:none", "-g", "-preserveAllLocals", "-nowarn", "-encoding", "UTF-8")
    }
}

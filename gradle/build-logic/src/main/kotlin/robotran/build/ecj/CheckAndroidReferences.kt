package robotran.build.ecj

import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Classpath
import org.gradle.api.tasks.OutputFile
import org.gradle.api.tasks.TaskAction
import java.io.File
import java.util.zip.ZipFile

/** Fails if [classes] use a class, method or field that neither they nor Android have. */
@CacheableTask
abstract class CheckAndroidReferences : DefaultTask() {
    /** Jars and folders of class files. */
    @get:Classpath
    abstract val classes: ConfigurableFileCollection

    /** `android.jar`. */
    @get:Classpath
    abstract val framework: ConfigurableFileCollection

    @get:OutputFile
    abstract val report: RegularFileProperty

    @TaskAction
    fun check() {
        val references = References()
        framework.forEach { file -> classFiles(file).forEach(references::addFramework) }
        classes.forEach { file -> classFiles(file).forEach(references::add) }
        val missing = references.missing()
        report.get().asFile.writeText(missing.joinToString("\n"))
        if (missing.isNotEmpty()) throw GradleException("Android does not have\n${missing.joinToString("\n")}")
    }

    private fun classFiles(file: File): List<ByteArray> = when {
        file.isDirectory -> file.walk().filter { it.extension == "class" }.map { it.readBytes() }.toList()

        else -> ZipFile(file).use { jar ->
            jar.entries().asSequence().filter { it.name.endsWith(".class") }.map { entry ->
                jar.getInputStream(entry).use { it.readBytes() }
            }.toList()
        }
    }
}

package robotran.build.android

import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Classpath
import org.gradle.api.tasks.OutputFile
import org.gradle.api.tasks.TaskAction

/** Fails if [classes] use a class, method or field that is missing in both them and Android. */
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
        val api = UsedApi()
        framework.forEach { file -> classFiles(file).forEach(api::declare) }
        classes.forEach { file -> classFiles(file).forEach(api::declareAndRead) }
        val missing = api.missing()
        report.get().asFile.writeText(missing.joinToString("\n"))
        if (missing.isNotEmpty()) throw GradleException("Android does not have\n${missing.joinToString("\n")}")
    }
}

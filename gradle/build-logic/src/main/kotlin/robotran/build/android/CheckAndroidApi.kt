package robotran.build.android

import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Classpath
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.OutputFile
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction

/** Fails if the code of an APK uses a class, method or field that the oldest or the newest Android it is for does not have. */
@CacheableTask
abstract class CheckAndroidApi : DefaultTask() {
    @get:InputDirectory
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val apkFolder: DirectoryProperty

    /** The signatures of the oldest Android, as Animal Sniffer keeps them. */
    @get:Classpath
    abstract val oldest: ConfigurableFileCollection

    /** `android.jar` of the newest. */
    @get:Classpath
    abstract val newest: ConfigurableFileCollection

    /** What looks at `SDK_INT` before it uses something newer, see [ApiAllowances]. */
    @get:InputFile
    @get:PathSensitive(PathSensitivity.NONE)
    abstract val allowances: RegularFileProperty

    @get:OutputFile
    abstract val report: RegularFileProperty

    @TaskAction
    fun check() {
        val allowed = ApiAllowances(allowances.get().asFile.readText())
        val (guarded, unguarded) = missing { declareSignatures(oldest.singleFile) }.partition(allowed::allows)
        val removed = missing { classFiles(newest.singleFile).forEach(::declare) }
        val faults = unguarded.map { "The oldest Android lacks $it" } + removed.map { "The newest Android lacks $it" } +
            allowed.needless.map { "Nothing needs the allowance $it" }
        report.get().asFile.writeText((faults + guarded.map { "Looks at SDK_INT before: $it" }).joinToString("\n", postfix = "\n"))
        if (faults.isNotEmpty()) throw GradleException("${faults.take(MOST_TOLD).joinToString("\n")}\n${faults.size} faults; all are in ${report.get()}")
        logger.lifecycle("Nothing is used that Android lacks; ${guarded.size} uses of newer methods look at SDK_INT before")
    }

    private fun missing(declarePlatform: UsedApi.() -> Unit): List<UsedApi.Use> {
        val api = UsedApi().apply(declarePlatform)
        apkFolder.asFileTree.files.filter { it.extension == "apk" }.forEach(api::declareAndReadDex)
        return api.missing()
    }

    private companion object {
        const val MOST_TOLD = 40
    }
}

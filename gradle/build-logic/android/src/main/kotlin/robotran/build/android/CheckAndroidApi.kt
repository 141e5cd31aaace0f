package robotran.build.android

import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Classpath
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.OutputFile
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction

/** Fails if an APK uses a class, method or field that its oldest or newest supported Android version lacks. */
@CacheableTask
abstract class CheckAndroidApi : DefaultTask() {
    @get:InputDirectory
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val apkFolder: DirectoryProperty

    /** The signatures of the oldest Android version, in Animal Sniffer's format. */
    @get:Classpath
    abstract val oldest: ConfigurableFileCollection

    @get:Input
    abstract val oldestApi: Property<Int>

    /** `android.jar` of the newest version. */
    @get:Classpath
    abstract val newest: ConfigurableFileCollection

    @get:Input
    abstract val newestApi: Property<Int>

    /** The uses that are guarded by an `SDK_INT` check, see [ApiAllowances]. */
    @get:InputFile
    @get:PathSensitive(PathSensitivity.NONE)
    abstract val allowances: RegularFileProperty

    @get:OutputFile
    abstract val report: RegularFileProperty

    @TaskAction
    fun check() {
        val allowed = ApiAllowances(allowances.get().asFile.readText())
        val missing = missing("API ${oldestApi.get()}") { declareSignatures(oldest.singleFile) } +
            missing("API ${newestApi.get()}") { classFiles(newest.singleFile).forEach(::declare) }
        val (guarded, unguarded) = missing.partition { (_, use) -> allowed.allows(use) }
        val faults =
            unguarded.map { (api, use) -> "$api lacks $use" } +
                allowed.needless.map { "Nothing needs the allowance $it" }
        val lines = faults + guarded.map { (api, use) -> "Only after a look at SDK_INT: $api lacks $use" }
        report.get().asFile.writeText(lines.joinToString("\n", postfix = "\n"))
        if (faults.isNotEmpty()) {
            throw GradleException(
                "${faults.take(MAX_REPORTED).joinToString("\n")}\n${faults.size} faults; all are in ${report.get()}",
            )
        }
        logger.lifecycle(
            "Nothing that API ${oldestApi.get()} or ${newestApi.get()} lacks is used without a look at SDK_INT before",
        )
    }

    private fun missing(platform: String, declarePlatform: UsedApi.() -> Unit): List<Pair<String, UsedApi.Use>> {
        val api = UsedApi().apply(declarePlatform)
        apkFolder.asFileTree.files.filter { it.extension == "apk" }.forEach(api::declareAndReadDex)
        return api.missing { OUTLINE in it }.map { platform to it }
    }

    private companion object {
        const val MAX_REPORTED = 40

        /**
         * R8 moves calls of newer methods to these classes, so that older Android versions do not have to verify them.
         */
        const val OUTLINE = "\$\$ExternalSyntheticApiModelOutline"
    }
}

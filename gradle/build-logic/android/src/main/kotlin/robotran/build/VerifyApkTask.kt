package robotran.build

import com.android.apksig.ApkVerifier
import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.OutputFile
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction

/** Fails unless every APK in a folder has a signature that Android accepts, like `apksigner verify`. */
@CacheableTask
abstract class VerifyApkTask : DefaultTask() {
    @get:InputDirectory
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val apkFolder: DirectoryProperty

    /** One line per APK: its name, its size, and its valid signature schemes. */
    @get:OutputFile
    abstract val report: RegularFileProperty

    @TaskAction
    fun verify() {
        val apks = apkFolder.asFileTree.files.filter { it.extension == "apk" }.sorted()
        if (apks.isEmpty()) throw GradleException("There is no APK in ${apkFolder.get()}")
        val lines = apks.map { apk ->
            val result = ApkVerifier.Builder(apk).build().verify()
            if (!result.isVerified) {
                throw GradleException("${apk.name} does not verify: ${result.allErrors.joinToString("; ")}")
            }
            val schemes = listOf(
                "v1" to result.isVerifiedUsingV1Scheme,
                "v2" to result.isVerifiedUsingV2Scheme,
                "v3" to result.isVerifiedUsingV3Scheme,
            )
            "${apk.name}: ${apk.length() / KILOBYTE} KB, signed by " +
                "${schemes.filter { it.second }.joinToString(" ") { it.first }}"
        }
        report.get().asFile.writeText(lines.joinToString("\n", postfix = "\n"))
        lines.forEach(logger::lifecycle)
    }

    private companion object {
        const val KILOBYTE = 1000
    }
}

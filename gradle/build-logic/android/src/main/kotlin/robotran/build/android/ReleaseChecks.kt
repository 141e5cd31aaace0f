package robotran.build.android

import com.android.build.api.artifact.SingleArtifact
import com.android.build.api.variant.ApplicationVariant
import org.gradle.api.Project
import org.gradle.api.artifacts.Configuration
import org.gradle.api.attributes.Usage
import org.gradle.api.provider.Provider
import org.gradle.api.tasks.TaskProvider
import org.gradle.language.base.plugins.LifecycleBasePlugin
import org.jetbrains.kotlin.gradle.plugin.KotlinPlatformType
import robotran.build.catalog

/** Checks whether the release, after R8, would run on every supported Android version. */
internal class ReleaseChecks(private val project: Project, private val variant: ApplicationVariant) {
    private val reports = project.layout.buildDirectory.dir("reports")

    fun register(verifyApk: TaskProvider<*>) {
        val checks = listOf(registerApiCheck(), registerShrunkRun(), verifyApk)
        project.tasks.register(TASK) {
            it.group = LifecycleBasePlugin.VERIFICATION_GROUP
            it.description = "Builds the release and looks whether it would run on every Android it is for."
            it.dependsOn(checks)
        }
    }

    private fun registerApiCheck(): TaskProvider<*> {
        val signatures = project.configurations.create("oldestAndroid") {
            it.isCanBeConsumed = false
            it.isTransitive = false
        }
        val library = catalog(project).findLibrary("android-oldest").get().get()
        project.dependencies.add(
            signatures.name,
            "${library.module}:${library.versionConstraint.requiredVersion}@signature",
        )
        return project.tasks.register("checkAndroidApi", CheckAndroidApi::class.java) {
            it.group = LifecycleBasePlugin.VERIFICATION_GROUP
            it.description = "Looks for classes and methods in the release that an Android it is for does not have."
            it.apkFolder.set(variant.artifacts.get(SingleArtifact.APK))
            it.oldest.from(signatures)
            it.oldestApi.set(AndroidPlugin.MIN_SDK)
            it.newest.from(framework())
            it.newestApi.set(AndroidPlugin.COMPILE_SDK)
            it.allowances.set(project.layout.projectDirectory.file("newer-api.txt"))
            it.report.set(reports.map { folder -> folder.file("androidApi.txt") })
        }
    }

    private fun registerShrunkRun(): TaskProvider<*> {
        val below = belowTheScreen()
        return project.tasks.register("runShrunk", RunR8Output::class.java) { task ->
            task.group = LifecycleBasePlugin.VERIFICATION_GROUP
            task.description = "Holds what R8 leaves of the app against the recorded runs, on the JVM."
            task.libraries.from(below)
            task.program.from(project.tasks.named("compileDebugUnitTestKotlin"))
            task.programPackage.set("robotran/android/recorded/")
            task.mainClass.set("robotran.android.recorded.ShrunkRunsKt")
            task.tree.set(project.rootProject.layout.projectDirectory)
            task.read.from(project.rootProject.fileTree("examples"))
            val recording = listOf("world", "programs", "projects").map { "shared/$it/src/commonTest/resources/runs" }
            task.read.from(recording.map { project.rootProject.fileTree(it) })
            // The Android plugin has an API for R8's mapping file, but not for the configuration file next to it.
            val shrinking = "minify${variant.name.replaceFirstChar(Char::uppercase)}WithR8"
            task.dependsOn(shrinking)
            task.configuration.set(
                project.layout.buildDirectory.file(
                    "intermediates/mapping/${variant.name}/$shrinking/configuration.txt",
                ),
            )
            task.framework.from(framework())
            task.shrunk.set(project.layout.buildDirectory.file("shrunk/robotran.jar"))
            task.report.set(reports.map { folder -> folder.file("runShrunk.txt") })
        }
    }

    /** The same jars as in the app: core modules have one for the JVM, which Android uses, too. */
    private fun belowTheScreen(): Configuration {
        val below = project.configurations.create("belowTheScreen") {
            it.isCanBeConsumed = false
            it.attributes { attributes ->
                attributes.attribute(
                    Usage.USAGE_ATTRIBUTE,
                    project.objects.named(Usage::class.java, Usage.JAVA_RUNTIME),
                )
                attributes.attribute(KotlinPlatformType.attribute, KotlinPlatformType.jvm)
            }
            it.dependencies.add(project.dependencies.project(mapOf("path" to ":shared:projects")))
        }
        // The program uses it to run suspending functions.
        project.dependencies.add(below.name, catalog(project).findLibrary("coroutines-core").get())
        return below
    }

    private fun framework(): Provider<String> = project.providers.environmentVariable("ANDROID_HOME").map {
        "$it/platforms/android-${AndroidPlugin.COMPILE_SDK}/android.jar"
    }

    companion object {
        const val TASK = "checkRelease"
    }
}

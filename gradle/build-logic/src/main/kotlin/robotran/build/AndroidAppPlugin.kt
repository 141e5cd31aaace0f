package robotran.build

import com.android.build.api.artifact.SingleArtifact
import com.android.build.api.dsl.ApplicationExtension
import com.android.build.api.variant.ApplicationAndroidComponentsExtension
import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.artifacts.VersionCatalogsExtension
import org.gradle.api.tasks.testing.Test
import org.gradle.language.base.plugins.LifecycleBasePlugin

/** The Android application: its debug APK, the check of its signature, and unit tests on Robolectric. */
class AndroidAppPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.pluginManager.apply("com.android.application")
        project.pluginManager.apply("org.jetbrains.kotlin.android")
        project.pluginManager.apply("org.jetbrains.kotlin.plugin.compose")
        project.pluginManager.apply(AndroidPlugin::class.java)
        project.extensions.configure(ApplicationExtension::class.java) { android ->
            android.defaultConfig.targetSdk = AndroidPlugin.COMPILE_SDK
            android.buildFeatures.compose = true
            android.testOptions.unitTests.isIncludeAndroidResources = true
        }
        verifyDebugApk(project)
        runUnitTestsOnRobolectric(project)
    }

    private fun verifyDebugApk(project: Project) {
        val verifyApk = project.tasks.register("verifyApk", VerifyApkTask::class.java) {
            it.group = LifecycleBasePlugin.VERIFICATION_GROUP
            it.description = "Checks the signature of the debug APK."
            it.report.set(project.layout.buildDirectory.file("reports/verifyApk.txt"))
        }
        val components = project.extensions.getByType(ApplicationAndroidComponentsExtension::class.java)
        components.onVariants(components.selector().withBuildType("debug")) { variant ->
            verifyApk.configure { it.apkFolder.set(variant.artifacts.get(SingleArtifact.APK)) }
        }
        project.tasks.named(LifecycleBasePlugin.CHECK_TASK_NAME) { it.dependsOn(verifyApk) }
    }

    private fun runUnitTestsOnRobolectric(project: Project) {
        val libraries = project.extensions.getByType(VersionCatalogsExtension::class.java).named("libs")
        val framework = project.configurations.create("robolectricFramework") {
            it.isCanBeConsumed = false
            it.isTransitive = false
        }
        project.dependencies.add(framework.name, libraries.findLibrary("robolectric-framework").get())
        val pictures = project.layout.buildDirectory.dir("pictures")
        project.tasks.withType(Test::class.java).configureEach { test ->
            test.jvmArgumentProviders.add(RobolectricArguments(project.files(framework), pictures))
            test.maxHeapSize = "2g"
        }
    }
}

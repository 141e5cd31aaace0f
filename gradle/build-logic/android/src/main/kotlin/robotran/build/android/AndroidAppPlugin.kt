package robotran.build.android

import com.android.build.api.artifact.SingleArtifact
import com.android.build.api.dsl.ApplicationExtension
import com.android.build.api.variant.ApplicationAndroidComponentsExtension
import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.artifacts.VersionCatalogsExtension
import org.gradle.api.tasks.testing.Test
import org.gradle.language.base.plugins.LifecycleBasePlugin
import robotran.build.Rings
import robotran.build.RobolectricArguments
import robotran.build.TestFolders
import robotran.build.VerifyApkTask

/** The Android application: its APKs, checks of their signatures and of R8's output, and unit tests on Robolectric. */
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
            PageUrl.configure(project, android)
            AndroidRelease.configure(project, android)
        }
        verifyApks(project)
        runUnitTestsOnRobolectric(project)
        leaveOutOfCheck(project)
    }

    /** Compiling for Android alone takes longer than `check` should for one platform, so all of it is in `checkAll`. */
    private fun leaveOutOfCheck(project: Project) {
        project.afterEvaluate {
            project.tasks.named(LifecycleBasePlugin.CHECK_TASK_NAME) { it.setDependsOn(emptyList<Any>()) }
        }
        Rings.addToAll(project, "testDebugUnitTest", ReleaseChecks.TASK)
    }

    private fun verifyApks(project: Project) {
        val components = project.extensions.getByType(ApplicationAndroidComponentsExtension::class.java)
        // Both variants have the same code, and the tests also need parts that the release omits.
        components.beforeVariants(components.selector().withBuildType(AndroidPlugin.RELEASE)) { release ->
            release.hostTests.values.forEach { it.enable = false }
        }
        components.onVariants { variant ->
            val verify = project.tasks.register(
                "verify${variant.name.replaceFirstChar { it.uppercase() }}Apk",
                VerifyApkTask::class.java,
            ) {
                it.group = LifecycleBasePlugin.VERIFICATION_GROUP
                it.description = "Checks the signature of the ${variant.name} APK and tells its size."
                it.apkFolder.set(variant.artifacts.get(SingleArtifact.APK))
                it.report.set(project.layout.buildDirectory.file("reports/verify-${variant.name}-apk.txt"))
            }
            if (variant.buildType == AndroidPlugin.RELEASE) {
                ReleaseChecks(project, variant).register(verify)
            } else {
                Rings.addToAll(project, verify)
            }
        }
    }

    private fun runUnitTestsOnRobolectric(project: Project) {
        val libraries = project.extensions.getByType(VersionCatalogsExtension::class.java).named("libs")
        val framework = project.configurations.create("robolectricFramework") {
            it.isCanBeConsumed = false
            it.isTransitive = false
        }
        project.dependencies.add(framework.name, libraries.findLibrary("robolectric-framework").get())
        project.tasks.withType(Test::class.java).configureEach { test ->
            test.jvmArgumentProviders.add(RobolectricArguments(project.files(framework)))
            test.maxHeapSize = "2g"
            TestFolders.giveTree(project, test)
            TestFolders.givePictures(project, test)
        }
    }
}

package robotran.build.android

import com.android.build.api.dsl.CommonExtension
import com.android.build.api.variant.AndroidComponentsExtension
import com.android.build.api.variant.HasAndroidTestBuilder
import com.android.build.api.variant.LibraryVariantBuilder
import org.gradle.api.JavaVersion
import org.gradle.api.Named
import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.language.base.plugins.LifecycleBasePlugin

/** What every module with an Android plugin (library or application) has in common. The namespace is its script's. */
class AndroidPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.pluginManager.withPlugin("com.android.base") {
            val android = project.extensions.getByName("android") as CommonExtension<*, *, *, *, *, *>
            android.compileSdk = COMPILE_SDK
            android.buildToolsVersion = BUILD_TOOLS
            android.defaultConfig.minSdk = MIN_SDK
            android.compileOptions.sourceCompatibility = JavaVersion.VERSION_17
            android.compileOptions.targetCompatibility = JavaVersion.VERSION_17
            buildWhatIsNeeded(project)
            leaveLintOut(project)
        }
    }

    /**
     * One variant of a library serves debug and release of the app; its code is tested on the desktop's JVM. Tests on a
     * device need a device.
     */
    private fun buildWhatIsNeeded(project: Project) {
        val components = project.extensions.getByType(AndroidComponentsExtension::class.java)
        components.beforeVariants { variant ->
            (variant as? HasAndroidTestBuilder)?.androidTest?.enable = false
            if (variant is LibraryVariantBuilder) {
                variant.enable = variant.buildType == DEBUG
                variant.hostTests.values.forEach { it.enable = false }
            }
        }
    }

    /**
     * Takes Lint out of `check`, which must do the same on every machine: it reads a database of Android's API that
     * only a full SDK has. `./gradlew lint` is still there for those who have one.
     */
    private fun leaveLintOut(project: Project) {
        project.afterEvaluate {
            project.tasks.named(LifecycleBasePlugin.CHECK_TASK_NAME) { check ->
                check.setDependsOn(check.dependsOn.filterNot { (it is Named && it.name == "lint") || it == "lint" })
            }
        }
    }

    companion object {
        /** Android 15: the newest that Robolectric runs on JDK 17. `gradle/android-sdk` makes the same. */
        const val COMPILE_SDK = 35
        const val BUILD_TOOLS = "35.0.0"

        const val DEBUG = "debug"
        const val RELEASE = "release"

        /** Android 8.0, the first with adaptive icons. */
        const val MIN_SDK = 26
    }
}

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

/** The configuration shared by all Android modules (library or application). */
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
     * Both build types of the app use one variant of a library, whose code is tested on the desktop JVM. Device tests
     * need a device and are disabled.
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
     * Removes Lint from `check`, which must give the same result on every machine: Lint needs an Android API database
     * of a full SDK. `./gradlew lint` still works with a full SDK.
     */
    private fun leaveLintOut(project: Project) {
        project.afterEvaluate {
            project.tasks.named(LifecycleBasePlugin.CHECK_TASK_NAME) { check ->
                check.setDependsOn(check.dependsOn.filterNot { (it is Named && it.name == "lint") || it == "lint" })
            }
        }
    }

    companion object {
        /** Android 15: the newest version that Robolectric runs on JDK 17, also in `gradle/bootstrap/android-sdk`. */
        const val COMPILE_SDK = 35
        const val BUILD_TOOLS = "35.0.0"

        const val DEBUG = "debug"
        const val RELEASE = "release"

        /** Android 8.0, the first version with adaptive icons. */
        const val MIN_SDK = 26
    }
}

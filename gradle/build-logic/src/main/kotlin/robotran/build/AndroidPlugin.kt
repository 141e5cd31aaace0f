package robotran.build

import com.android.build.api.dsl.CommonExtension
import org.gradle.api.JavaVersion
import org.gradle.api.Plugin
import org.gradle.api.Project

/** What every module with Android's plugin (library or application) has in common. The namespace is its script's. */
class AndroidPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.pluginManager.withPlugin("com.android.base") {
            val android = project.extensions.getByName("android") as CommonExtension<*, *, *, *, *, *>
            android.compileSdk = COMPILE_SDK
            android.buildToolsVersion = BUILD_TOOLS
            android.defaultConfig.minSdk = MIN_SDK
            android.compileOptions.sourceCompatibility = JavaVersion.VERSION_17
            android.compileOptions.targetCompatibility = JavaVersion.VERSION_17
        }
    }

    companion object {
        /** Android 15: the newest that Robolectric runs on JDK 17. gradle/android-sdk makes the same. */
        const val COMPILE_SDK = 35
        const val BUILD_TOOLS = "35.0.0"

        /** Android 8.0, the first with adaptive icons and the java.time classes. */
        const val MIN_SDK = 26
    }
}

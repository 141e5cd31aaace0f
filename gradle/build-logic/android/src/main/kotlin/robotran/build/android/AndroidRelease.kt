package robotran.build.android

import com.android.build.api.dsl.ApkSigningConfig
import com.android.build.api.dsl.ApplicationExtension
import org.gradle.api.Project

/**
 * The release of the Android app: shrunk by R8, and signed with a key from Gradle properties or environment variables.
 */
internal object AndroidRelease {
    private const val KEYSTORE = "ROBOTRAN_KEYSTORE"
    private const val KEYSTORE_PASSWORD = "ROBOTRAN_KEYSTORE_PASSWORD"
    private const val KEY_ALIAS = "ROBOTRAN_KEY_ALIAS"
    private const val KEY_PASSWORD = "ROBOTRAN_KEY_PASSWORD"

    /** R8's keep rules, next to the app's build script. */
    const val KEEP_RULES = "keep-rules.pro"

    fun configure(project: Project, android: ApplicationExtension) {
        val keystore = setting(project, KEYSTORE)
        // A pupil may choose a language other than the device's without Internet access.
        android.bundle.language.enableSplit = false
        // Lint needs files that only a full SDK has.
        android.lint.checkReleaseBuilds = false
        val release = android.buildTypes.getByName(AndroidPlugin.RELEASE)
        release.isMinifyEnabled = true
        release.isShrinkResources = true
        release.proguardFiles(android.getDefaultProguardFile("proguard-android-optimize.txt"), project.file(KEEP_RULES))
        // The libraries have only one variant.
        release.matchingFallbacks.add(AndroidPlugin.DEBUG)
        release.signingConfig = when (keystore) {
            null -> android.signingConfigs.getByName(AndroidPlugin.DEBUG)
            else -> android.signingConfigs.create(AndroidPlugin.RELEASE) { sign(project, it, keystore) }
        }
        if (keystore == null) sayThatItIsForTrialsOnly(project)
    }

    private fun sign(project: Project, config: ApkSigningConfig, keystore: String) {
        config.storeFile = project.rootProject.file(keystore)
        config.storePassword = setting(project, KEYSTORE_PASSWORD)
        config.keyAlias = setting(project, KEY_ALIAS)
        config.keyPassword = setting(project, KEY_PASSWORD) ?: config.storePassword
    }

    private fun sayThatItIsForTrialsOnly(project: Project) {
        project.tasks.configureEach { task ->
            if (task.name != "packageRelease" && task.name != "signReleaseBundle") return@configureEach
            task.doLast {
                it.logger.lifecycle(
                    "Signed with the debug key, for trials only: $KEYSTORE names no keystore (docs/android.md).",
                )
            }
        }
    }
}

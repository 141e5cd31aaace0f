package robotran.build

import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.work.DisableCachingByDefault

/**
 * Fails if the wrapper's jar is not the one that Gradle publishes, or the distribution is not pinned by its published
 * checksum.
 */
@DisableCachingByDefault(because = "Reading two small files is faster than a cache")
abstract class CheckGradleWrapper : DefaultTask() {
    @get:InputFile
    @get:PathSensitive(PathSensitivity.NONE)
    abstract val jar: RegularFileProperty

    @get:InputFile
    @get:PathSensitive(PathSensitivity.NONE)
    abstract val properties: RegularFileProperty

    @TaskAction
    fun check() {
        if (sha256(jar.get().asFile) != WRAPPER_SHA256) {
            throw GradleException("gradle-wrapper.jar is not the one Gradle $GRADLE_VERSION publishes.")
        }
        val lines = properties.get().asFile.readLines()
        if ("distributionSha256Sum=$DISTRIBUTION_SHA256" !in lines ||
            lines.none { it.endsWith("gradle-$GRADLE_VERSION-bin.zip") }
        ) {
            throw GradleException(
                "gradle-wrapper.properties does not pin Gradle $GRADLE_VERSION by its published checksum.",
            )
        }
    }

    private companion object {
        // Published at gradle.org/release-checksums.
        const val GRADLE_VERSION = "8.11.1"
        const val WRAPPER_SHA256 = "2db75c40782f5e8ba1fc278a5574bab070adccb2d21ca5a6e5ed840888448046"
        const val DISTRIBUTION_SHA256 = "f397b287023acdba1e9f6fc5ea72d22dd63669d59ed4a289a29b1a76eee151c6"
    }
}

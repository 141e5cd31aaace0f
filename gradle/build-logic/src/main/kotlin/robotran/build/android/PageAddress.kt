package robotran.build.android

import com.android.build.api.dsl.ApplicationExtension
import org.gradle.api.GradleException
import org.gradle.api.Project
import java.net.URI

/**
 * Where Robotran's page is, as the Gradle property or environment variable `ROBOTRAN_PAGE` says: links that the app
 * makes begin with it, and such links open in the app. Without it they are the part behind the `#` alone.
 */
internal object PageAddress {
    private const val PAGE = "ROBOTRAN_PAGE"

    /** No page is ever there (RFC 2606). */
    private const val NOWHERE = "https://robotran.invalid/"

    fun configure(project: Project, android: ApplicationExtension) {
        val page = setting(project, PAGE)
        val address = URI(page ?: NOWHERE)
        if (address.scheme != "https" || address.host == null || address.fragment != null) {
            throw GradleException("$PAGE is to be an address like https://example.org/robotran/, and not $page")
        }
        android.defaultConfig.resValue("string", "page_address", page.orEmpty())
        android.defaultConfig.manifestPlaceholders["pageHost"] = address.host
        android.defaultConfig.manifestPlaceholders["pagePath"] = address.path.ifEmpty { "/" }
    }
}

/** What a Gradle property or else an environment variable says; null if neither is there. */
internal fun setting(project: Project, name: String): String? =
    project.providers.gradleProperty(name).orElse(project.providers.environmentVariable(name)).orNull

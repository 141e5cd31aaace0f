package robotran.build.android

import com.android.build.api.dsl.ApplicationExtension
import org.gradle.api.GradleException
import org.gradle.api.Project
import java.net.URI

/**
 * The URL of Robotran's page from the Gradle property or environment variable `ROBOTRAN_PAGE`. Links made by the app
 * start with this URL, and the app opens such links. Without it, links consist of the fragment after `#` only.
 */
internal object PageUrl {
    private const val PAGE = "ROBOTRAN_PAGE"

    /** A domain that never exists (RFC 2606). */
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

/** The value of a Gradle property or else of an environment variable; null if neither is set. */
internal fun setting(project: Project, name: String): String? =
    project.providers.gradleProperty(name).orElse(project.providers.environmentVariable(name)).orNull

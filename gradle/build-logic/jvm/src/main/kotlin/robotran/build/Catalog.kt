package robotran.build

import org.gradle.api.Project
import org.gradle.api.artifacts.VersionCatalog
import org.gradle.api.artifacts.VersionCatalogsExtension

/** `gradle/libs.versions.toml` for plugins, which have no generated accessors. */
fun catalog(project: Project): VersionCatalog =
    project.extensions.getByType(VersionCatalogsExtension::class.java).named("libs")

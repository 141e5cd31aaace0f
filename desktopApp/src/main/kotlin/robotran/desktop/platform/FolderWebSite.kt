package robotran.desktop.platform

import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import robotran.assignments.packaging.SiteFile
import robotran.cli.packaging.readSiteFiles
import robotran.siteserver.SiteServer
import robotran.workshop.platform.WebSite
import java.nio.file.Path
import kotlin.io.path.Path

/** The site in [folder], as `./gradlew :webApp:dist` makes it. */
internal class FolderWebSite(private val folder: Path) : WebSite {
    override suspend fun files(): List<SiteFile>? = withContext(Dispatchers.IO) { readSiteFiles(folder) }

    companion object {
        /** The site of the source tree that this process was started from; null if it is not built. */
        fun ofThisProcess(): FolderWebSite? = System.getProperty("robotran.site")
            ?.let { Path(it) }?.takeIf(SiteServer::hasSite)?.let(::FolderWebSite)
    }
}

package robotran.workshop.platform

import robotran.assignments.packaging.SiteFile

/** The built web site that this app is or has with it, to be put into packages for learning platforms. */
interface WebSite {
    /** All its files; null if not all of them can be read now. */
    suspend fun files(): List<SiteFile>?
}

package robotran.projects

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull

class SiteAddressTest {
    @Test
    fun addressesOfSitesAreTakenAsTheyAre() {
        val addresses = listOf(
            "https://school.example/robotran/",
            "http://192.168.0.7:8080/",
            "http://[::1]:8080/?embed",
            "HTTPS://schule-süd.example",
        )
        for (address in addresses) assertEquals(address, siteAddress(" $address\n"))
        assertEquals("https://school.example/robotran/", siteAddress("https://school.example/robotran/#p=aAAAA"))
    }

    @Test
    fun anythingElseIsNone() {
        val others = listOf(
            "",
            " ",
            "school.example",
            "https://",
            "https:///robotran",
            "https://?x",
            "ftp://school.example",
            "javascript://school.example/%0aalert(1)",
            "file:///home/robotran",
            "https://school.example/a b",
            "https://school.example@evil.example/",
            "https://school.example/\u0000",
            "https://.example",
            "https://school.example/<script>",
            "https://school.example/" + "a".repeat(ProjectLimits.MAXIMUM_SITE_CHARACTERS),
            "#p=aAAAA",
        )
        for (other in others) assertNull(siteAddress(other), other)
    }
}

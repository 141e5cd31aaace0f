plugins {
    id("robotran.core")
    id("robotran.texts")
}

texts {
    constant("commonTest", "robotran.hub.recordedRuns", "shared/hub/src/commonTest/resources/recorded", "*.txt")
    constant("commonTest", "robotran.hub.driveBases", "shared/hub/src/commonTest/resources", "drive-bases.txt")
    constant("commonTest", "robotran.hub.documents", "docs", "hubs.md")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:brick"))
            api(project(":shared:language"))
        }
    }
}

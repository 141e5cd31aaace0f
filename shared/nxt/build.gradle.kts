plugins {
    id("robotran.core")
    id("robotran.texts")
}

texts {
    constant("commonTest", "robotran.nxt.nxtScripts", "shared/nxt/src/commonTest/resources/scripts", "**/*.txt")
    constant("commonTest", "robotran.nxt.displayGoldens", "shared/nxt/src/commonTest/resources/displays", "*.txt")
    constant("commonTest", "robotran.nxt.documents", "docs", "nxt.md")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:brick"))
            api(project(":shared:language"))
        }
        commonTest {
            kotlin.srcDir("src/fakeNxtTest/kotlin")
        }
    }
}

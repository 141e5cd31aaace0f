plugins {
    id("robotran.core")
    id("robotran.ecj-web")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:language-support"))
        }
        commonTest.dependencies {
            implementation(project(":shared:programs"))
            implementation(project(":shared:nxj-library"))
        }
    }
}

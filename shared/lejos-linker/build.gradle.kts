plugins {
    id("robotran.core")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:tinyvm"))
        }
        commonTest.dependencies {
            implementation(project(":shared:lejos-library"))
        }
    }
}

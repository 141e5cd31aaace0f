plugins {
    id("robotran.core")
    id("robotran.ecj-web")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:rcx-rom"))
            api(project(":shared:robolang"))
            api(project(":shared:tinyvm"))
            api(project(":shared:java-compiler"))
            implementation(project(":shared:lejos-library"))
        }
    }
}

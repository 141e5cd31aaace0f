plugins {
    id("robotran.core")
    id("robotran.ecj-web")
    id("robotran.physics-web")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:learning"))
            api(project(":shared:documents"))
            api(project(":shared:projects"))
            api(project(":shared:simulation"))
        }
    }
}

plugins {
    id("robotran.core")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:language"))
            implementation(project(":shared:json"))
        }
    }
}

plugins {
    id("robotran.web")
}

kotlin {
    sourceSets {
        wasmJsMain.dependencies {
            implementation(project(":shared:ui"))
        }
    }
}

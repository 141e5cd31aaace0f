plugins {
    id("robotran.web")
}

kotlin {
    sourceSets {
        wasmJsMain.dependencies {
            implementation(project(":shared:ui"))
            implementation(project(":shared:projects"))
            implementation(project(":shared:documents"))
            implementation(project(":shared:hub-link"))
            implementation(project(":shared:microbit-link"))
            implementation(project(":shared:mpy-compiler"))
            implementation(libs.coroutines.core)
            implementation(compose.components.resources)
            implementation(npm("qr", "0.7.0"))
            implementation(npm("@pybricks/mpy-cross-v6", "2.0.0"))
        }
    }
}

plugins {
    id("java-gradle-plugin")
    alias(libs.plugins.kotlin.jvm)
}

dependencies {
    implementation(libs.plugin.kotlin)
    implementation(libs.plugin.android)
    implementation(libs.apksig)
}

gradlePlugin {
    plugins {
        create("root") {
            id = "robotran.root"
            implementationClass = "robotran.build.RootPlugin"
        }
        create("core") {
            id = "robotran.core"
            implementationClass = "robotran.build.CorePlugin"
        }
        create("android") {
            id = "robotran.android"
            implementationClass = "robotran.build.AndroidPlugin"
        }
        create("androidApp") {
            id = "robotran.android.app"
            implementationClass = "robotran.build.AndroidAppPlugin"
        }
    }
}

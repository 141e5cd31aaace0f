plugins {
    id("java-gradle-plugin")
    alias(libs.plugins.kotlin.jvm)
}

dependencies {
    implementation(libs.plugin.kotlin)
    implementation(libs.plugin.android)
    implementation(libs.apksig)
    testImplementation(libs.kotlin.test)
}

tasks.test {
    useJUnitPlatform()
}

gradlePlugin {
    testSourceSets() // none: the tests are plain unit tests, and an embedded Gradle has no TestKit
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

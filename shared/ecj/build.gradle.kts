plugins {
    id("robotran.ecj")
}

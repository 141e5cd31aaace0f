// hint: nothing changed
// Measures how warm it is, and shows tenths of a degree.

import josx.platform.rcx.LCD;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorConstants;
import josx.platform.rcx.Sound;

class Thermometer {
    static final int TOO_WARM = 25; // degrees Celsius

    public static void main(String[] args) throws InterruptedException {
        Sensor.S1.setTypeAndMode(SensorConstants.SENSOR_TYPE_TEMP, SensorConstants.SENSOR_MODE_DEGC);
        Thread.sleep(100); // until it has measured
        int tenths = Sensor.S1.readValue();
        LCD.showNumber(tenths);
        Thread.sleep(1000);
    }
}

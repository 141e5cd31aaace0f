public class LongsAndBytes {
    public static void main(String[] arguments) {
        System.out.println(Long.toString(-255, 16) + " " + Long.toBinaryString(5) + " " + Long.toOctalString(64)); // expect -ff 101 100
        System.out.println(Long.bitCount(-1L) + " " + Long.numberOfLeadingZeros(1) + " " + Long.highestOneBit(1000L)); // expect 64 63 512
        System.out.println(Long.reverse(1L) + " " + Long.rotateLeft(1L, 63) + " " + Long.bitCount(-5L)); // expect -9223372036854775808 -9223372036854775808 63
        System.out.println(Long.valueOf("77").longValue() + " " + new Long(3).equals(3L) + " " + Long.valueOf(5).compareTo(6L)); // expect 77 true -1
        System.out.println(Byte.MAX_VALUE + " " + Byte.MIN_VALUE + " " + Short.MAX_VALUE + " " + (int) Character.MAX_VALUE); // expect 127 -128 32767 65535
        System.out.println(Byte.valueOf((byte) 3).hashCode() + " " + Short.valueOf((short) -4).intValue()); // expect 3 -4
        System.out.println(Float.MAX_VALUE + " " + Float.MIN_VALUE + " " + Double.MAX_VALUE + " " + Double.MIN_VALUE);
        // expect 3.4028235E38 1.4E-45 1.7976931348623157E308 4.9E-324
        System.out.println(Float.isNaN(Float.NaN) + " " + Float.compare(1, 2) + " " + new Float(2.5).equals(2.5f)); // expect true -1 true
        System.out.println(Double.valueOf("1e-3") + " " + Double.toString(123456789.125) + " " + new Double(0.1).hashCode());
        // expect 0.001 1.23456789125E8 -1507852285
        System.out.println(Character.valueOf('q').charValue() + " " + Character.toString('z') + " " + Character.MIN_RADIX); // expect q z 2
        Number[] numbers = {1, 2L, 3.5f, 4.5, (byte) 5, (short) 6};
        double sum = 0;
        for (Number number : numbers) sum += number.doubleValue() + number.intValue();
        System.out.println(sum); // expect 43.0
        String[] wrong = {"", "1e", "x", "1.2.3", "--1"};
        for (String text : wrong) {
            try {
                System.out.println(Double.parseDouble(text));
            } catch (NumberFormatException no) {
                System.out.println("no number"); // expect no number
                // expect no number
                // expect no number
                // expect no number
                // expect no number
            }
        }
    }
}

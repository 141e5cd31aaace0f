public class Numbers {
    static String parsed(String text) {
        try {
            return "" + Integer.parseInt(text);
        } catch (NumberFormatException wrong) {
            return "no number";
        }
    }

    public static void main(String[] arguments) {
        System.out.println(parsed("42") + " " + parsed("-7") + " " + parsed("x") + " " + parsed("") + " " + parsed("2147483648"));
        // expect 42 -7 no number no number no number
        System.out.println(Integer.parseInt("ff", 16) + " " + Integer.parseInt("-101", 2)); // expect 255 -5
        System.out.println(Integer.toHexString(255) + " " + Integer.toHexString(-1) + " " + Integer.toBinaryString(10)); // expect ff ffffffff 1010
        System.out.println(Integer.toString(255, 36) + " " + Integer.toOctalString(8)); // expect 73 10
        System.out.println(Integer.MAX_VALUE + " " + Integer.MIN_VALUE); // expect 2147483647 -2147483648
        System.out.println(Long.parseLong("-9000000000") + " " + Long.MAX_VALUE + " " + Long.toHexString(1L << 40));
        // expect -9000000000 9223372036854775807 10000000000
        System.out.println(Double.parseDouble("1.5e3") + " " + Double.parseDouble("-.25") + " " + Float.parseFloat("3")); // expect 1500.0 -0.25 3.0
        System.out.println(Double.isNaN(0.0 / 0) + " " + Double.isInfinite(1 / 0.0)); // expect true true
        System.out.println(Double.compare(1.0, 2.0) + " " + Double.compare(0.0, -0.0)); // expect -1 1
        System.out.println(Byte.parseByte("-128") + " " + Short.parseShort("300")); // expect -128 300
        System.out.println(Integer.bitCount(255) + " " + Integer.reverse(1) + " " + Integer.highestOneBit(100)); // expect 8 -2147483648 64
        System.out.println(Long.numberOfTrailingZeros(1L << 40)); // expect 40
        System.out.println(Float.floatToIntBits(1.5f) + " " + (Float.intBitsToFloat(0x40490fdb) == 3.1415927f)); // expect 1069547520 true
        System.out.println(Double.doubleToLongBits(-2.0) + " " + Double.longBitsToDouble(0x3ff8000000000000L)); // expect -4611686018427387904 1.5
        System.out.println(Integer.valueOf(7).compareTo(9) + " " + new Double(2.5).intValue() + " " + new Integer(3).doubleValue()); // expect -1 2 3.0
        System.out.println(Boolean.parseBoolean("TRUE") + " " + Boolean.valueOf("no")); // expect true false
        System.out.println(Character.isDigit('7') + " " + Character.digit('f', 16) + " " + Character.forDigit(11, 16)); // expect true 15 b
    }
}

public class RunLengths {
    static String packed(String text) {
        StringBuilder result = new StringBuilder();
        int place = 0;
        while (place < text.length()) {
            char letter = text.charAt(place);
            int end = place;
            do end++; while (end < text.length() && text.charAt(end) == letter);
            if (end - place > 1) result.append(end - place);
            result.append(letter);
            place = end;
        }
        return result.toString();
    }

    static String unpacked(String text) {
        StringBuilder result = new StringBuilder();
        int times = 0;
        for (char letter : text.toCharArray()) {
            if (letter >= '0' && letter <= '9') {
                times = times * 10 + letter - '0';
            } else {
                do result.append(letter); while (--times > 0);
                times = 0;
            }
        }
        return result.toString();
    }

    static String shifted(String text, int by) {
        char[] letters = text.toCharArray();
        for (int i = 0; i < letters.length; i++) {
            char letter = letters[i];
            if (letter >= 'a' && letter <= 'z') letters[i] = (char) ('a' + (letter - 'a' + by + 26) % 26);
        }
        return new String(letters);
    }

    public static void main(String[] arguments) {
        String[] texts = {"aaabccddddddddddddd", "xyz", "", "zz top", "ffffffffff"};
        for (String text : texts) {
            String packed = packed(text);
            System.out.println(packed + " " + packed.length() + " " + unpacked(packed).equals(text));
        }
        System.out.println(shifted("robots hum, xylophones too", 5));
        System.out.println(shifted(shifted("robots hum", 5), -5));
        // expect 3ab2c13d 8 true
        // expect xyz 3 true
        // expect  0 true
        // expect 2z top 6 true
        // expect 10f 3 true
        // expect wtgtyx mzr, cdqtumtsjx ytt
        // expect robots hum
    }
}

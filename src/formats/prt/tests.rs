use super::*;

const TRIANGLE: &str = "(0 0 0 ) (1.5 0 0 ) (0 1 0 )";

fn cells(text: &str) -> (Dialect, u32, Vec<u32>) {
    let file = read(text.as_bytes()).unwrap_or_else(|error| panic!("{text}: {error}"));
    assert_eq!(file.portals.len(), 1);
    assert_eq!(file.portals[0].cells, [1, 0]);
    let coordinates = &file.portals[0].vertices[1];
    assert_eq!(*coordinates, [Number::Small(3, 2), Number::Small(0, 1), Number::Small(0, 1)]);
    (file.dialect, file.cells, file.leaf_to_cell)
}

#[test]
fn every_dialect_is_read() {
    let portal = format!("3 1 0 {TRIANGLE} ");
    let cases = [
        (format!("PRT1\n2\n1\n{portal}\n"), Dialect::Prt1, vec![0, 1]),
        (format!("PRT2\n3\n2\n1\n{portal}\n2 0 -1\n1 -1\n"), Dialect::Prt2, vec![0, 1, 0]),
        (format!("PRT1-AM\n2\n1\n3\n{portal}\n1\n1\n0\n"), Dialect::Prt1Am, vec![1, 1, 0]),
        (
            format!("PRT1\n2\n1\n1\n3 1 0 0 {TRIANGLE}\n3 1 {TRIANGLE}\n"),
            Dialect::Quake3,
            vec![0, 1],
        ),
        (format!("2\n1\n{portal}\n"), Dialect::Headless, vec![0, 1]),
        (format!("2\n1\n1\n3\n{portal}\n"), Dialect::Headless, vec![0, 1, 1, 1]),
    ];
    for (text, dialect, leafs) in cases {
        assert_eq!(cells(&text), (dialect, 2, leafs.clone()), "{text}");
        let windows = text.replace('\n', "\r\n\r\n");
        assert_eq!(cells(&windows), (dialect, 2, leafs.clone()));
        let tight = text.replace(" )", ")");
        assert_eq!(cells(tight.trim_end()), (dialect, 2, leafs));
    }
}

#[test]
fn a_broken_rule_is_named_with_its_line() {
    let huge = "9".repeat(30);
    let portal = |text: &str| format!("PRT1\n2\n1\n{text}\n");
    let prt2 = |tail: &str| format!("PRT2\n3\n2\n1\n3 1 0 {TRIANGLE}\n{tail}");
    let cases = [
        ("".to_owned(), "line 1: the file is empty"),
        ("\n \n".to_owned(), "line 1: the file is empty"),
        ("PRT3\n".to_owned(), "line 1: expected PRT1, PRT2, PRT1-AM or a number"),
        ("PRT1".to_owned(), "line 2: the file ends, expected the number of leafs"),
        ("PRT1\n2".to_owned(), "line 3: the file ends, expected the number of portals"),
        ("PRT1\n-2\n1\n".to_owned(), "line 2: expected the number of leafs, got `-2`"),
        ("PRT1\n2 1\n1\n".to_owned(), "line 2: expected a line with the number of leafs alone"),
        (format!("PRT1\n{huge}\n1\n"), "line 2: expected the number of leafs, got `999"),
        ("PRT1\n4000000000\n1\n".to_owned(), "line 2: the number of leafs is 4000000000, at most"),
        (format!("PRT1\n2\n{huge}\n"), "line 3: expected the number of portals"),
        ("PRT1\n2\n1000000000000\n".to_owned(), "line 4: the file ends, expected another portal"),
        (portal(&format!("3 0 2 {TRIANGLE}")), "line 4: portal names cell 2, but there are 2"),
        (portal(&format!("3 0 -1 {TRIANGLE}")), "line 4: expected a portal's cell, got `-1`"),
        (portal("2 0 1 (0 0 0 ) (1 0 0 )"), "line 4: portal with 2 vertices"),
        (portal(&format!("4 0 1 {TRIANGLE}")), "line 4: expected 4 vertices `(x y z )`, got 3"),
        (portal(&format!("2000000000000000000 0 1 {TRIANGLE}")), "vertices `(x y z )`, got 3"),
        (portal("3 0 1 (0 0 0 ) (1 0 0 ) 0 1 0"), "expected `(` in vertex 2, got `0`"),
        (portal("3 0 1 (0 0 0 ) (1 0 0 ) (0 1 0 0"), "expected `)` in vertex 2, got `0`"),
        (portal("3 0 1 (0 0 0 ) (1 0 0 ) (0 1"), "expected `x y z` in vertex 2"),
        (portal("3 0 1 (0 0 0 ) (1 0 1e9999 ) (0 1 0 )"), "vertex 1: coordinate `1e9999`: the"),
        (portal("3 0 1 (0 0 0 ) (1 inf 0 ) (0 1 0 )"), "vertex 1: coordinate `inf`: not a"),
        (portal(&format!("3 0 1 {TRIANGLE}\n3")), "line 5: expected the end of the file after"),
        (prt2("0 1 -1\n"), "line 7: the file ends, expected a cluster's leafs"),
        (prt2("0 1 -1\n2\n"), "line 7: expected the cluster's leafs to end with -1"),
        (prt2("0 1 -1\n2 -1 3\n"), "line 7: expected the cluster's leafs to end with -1"),
        (prt2("0 1 -1\n3 -1\n"), "line 7: cluster names leaf 3, but there are 3 leafs"),
        (prt2("0 1 -1\n1 -1\n"), "line 7: leaf 1 is listed by cluster 0 and by cluster 1"),
        (prt2("0 -1\n1 -1\n"), "line 7: leaf 2 is in no cluster"),
        (format!("PRT1-AM\n2\n1\n1\n3 1 0 {TRIANGLE}\n2\n"), "line 6: portal names cell 2"),
        ("PRT1\n2\n1\n\u{e4}\n".to_owned(), "line 4: not a text of ASCII characters"),
        ("PRT1\n2\n1\n\0\n".to_owned(), "line 4: not a text of ASCII characters"),
    ];
    for (text, expected) in cases {
        let error = read(text.as_bytes()).unwrap_err().to_string();
        assert!(error.contains(expected), "{text}: {error}");
    }
}
